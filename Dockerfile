# The workbench in a container: slim, without root, on a read-only file system; training runs lie in a volume.
#   docker build -t laplace .            (on Linux, add --build-arg TORCH_INDEX=<address of torch's CPU index>
#   docker run -p 8501:8501 laplace       to spare gigabytes of GPU libraries)
# The base is one image, not whatever bears its name today; `docker buildx imagetools inspect` tells a newer digest.
FROM python:3.11.15-slim-bookworm@sha256:d29f48a31a8b408ed19272ca1e7b10ebae13b240a27e862d3d4217c528e2e0c3

ARG TORCH_INDEX=""
ENV PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1 HOME=/tmp LAPLACE_RUNS=/srv/runs

WORKDIR /srv/laplace
COPY requirements.lock requirements-cpu.lock requirements-cuda.lock ./
# Every package by its hash. Where no build of torch without CUDA is found, the one with CUDA is taken.
RUN install="python -m pip install --no-cache-dir --require-hashes --no-deps" && $install -r requirements.lock \
  && ($install ${TORCH_INDEX:+--extra-index-url "$TORCH_INDEX"} -r requirements-cpu.lock || $install -r requirements-cuda.lock)
COPY .streamlit .streamlit
COPY laplace_core laplace_core
COPY app app
COPY checkpoints checkpoints
COPY docs docs
COPY README.md CONTRIBUTING.md CHANGELOG.md ./
RUN python -m app.components.assets
# Whoever the container runs as may write here, and nowhere else but /tmp.
RUN install --directory --mode=1777 /srv/runs
VOLUME /srv/runs

USER 10001:10001
EXPOSE 8501
# Behind a proxy with a path, STREAMLIT_SERVER_BASE_URL_PATH, the page of health has that path in front as well.
HEALTHCHECK --interval=30s --timeout=5s --start-period=30s \
  CMD ["python", "-c", "import os, urllib.request as u; path = os.environ.get('STREAMLIT_SERVER_BASE_URL_PATH', '').strip('/'); u.urlopen('http://127.0.0.1:8501' + ('/' + path if path else '') + '/_stcore/health', timeout=4)"]
CMD ["python", "-m", "streamlit", "run", "app/main.py", "--server.address=0.0.0.0", "--server.port=8501", "--server.headless=true", "--server.fileWatcherType=none"]
