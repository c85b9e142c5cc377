# The workbench in a container: slim, without root, on a read-only file system.
#   docker build -t laplace .            (on Linux, add --build-arg TORCH_INDEX=<address of torch's CPU index>
#   docker run -p 8501:8501 laplace       to spare gigabytes of GPU libraries)
FROM python:3.11-slim

ARG TORCH_INDEX=""
ENV PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1 HOME=/tmp

WORKDIR /srv/laplace
COPY requirements.txt ./
RUN python -m pip install --no-cache-dir ${TORCH_INDEX:+--extra-index-url "$TORCH_INDEX"} -r requirements.txt
COPY .streamlit .streamlit
COPY laplace_core laplace_core
COPY app app
COPY checkpoints checkpoints
RUN python -m app.components.assets
# A volume takes over the mode of the folder that it lies on.
RUN mkdir runs && chmod 1777 runs

USER 10001:10001
EXPOSE 8501
HEALTHCHECK --interval=30s --timeout=5s --start-period=30s \
  CMD ["python", "-c", "import urllib.request; urllib.request.urlopen('http://127.0.0.1:8501/_stcore/health', timeout=4)"]
CMD ["python", "-m", "streamlit", "run", "app/main.py", "--server.address=0.0.0.0", "--server.port=8501", "--server.headless=true", "--server.fileWatcherType=none"]
