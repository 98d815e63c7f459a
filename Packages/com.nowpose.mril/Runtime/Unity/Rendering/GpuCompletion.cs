using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// Measures the time from the trigger of a render job to its completion on the GPU. For this it requests a readback after the job: the GPU
    /// works in order, so the readback completes after the job.
    /// </summary>
    /// <remarks>The engine checks for completed readbacks once per frame, so the resolution is one frame.</remarks>
    sealed class GpuCompletion
    {
        /// <summary>Maximum number of readbacks in progress: more than the frames that a GPU queues. Frames beyond it are not measured.</summary>
        const int MaxInFlight = 4;

        readonly IHeadsetClock _clock;
        readonly Action<AsyncGPUReadbackRequest> _onRead;
        readonly HeadsetTime[] _triggers = new HeadsetTime[MaxInFlight];
        Texture2D _texture;
        TimeSpan _newest;
        int _first, _inFlight;

        public GpuCompletion(IHeadsetClock clock)
        {
            _clock = clock;
            _onRead = Read;
        }

        /// <summary>Returns the newest time measured since the last call; zero if there is none.</summary>
        public TimeSpan Take()
        {
            var newest = _newest;
            _newest = TimeSpan.Zero;
            return newest;
        }

        /// <summary>Starts a measurement. Call it when a render job has been submitted to the GPU.</summary>
        /// <param name="triggered">Time at which rendering started.</param>
        public void Submitted(HeadsetTime triggered)
        {
            if (_inFlight == MaxInFlight || !SystemInfo.supportsAsyncGPUReadback) return;
            if (_texture == null) _texture = Uploaded();
            _triggers[(_first + _inFlight++) % MaxInFlight] = triggered;
            AsyncGPUReadback.Request(_texture, 0, _onRead);
        }

        /// <summary>Releases the texture. Readbacks in progress may still complete, but nothing uses their times.</summary>
        public void Release()
        {
            if (_texture != null) Object.Destroy(_texture);
            _texture = null;
        }

        // Apply uploads the texture; without the upload it may not exist on the GPU, so the readback would fail.
        static Texture2D Uploaded()
        {
            var texture = new Texture2D(1, 1) { hideFlags = HideFlags.HideAndDontSave };
            texture.Apply();
            return texture;
        }

        // Readbacks complete in order, so this is the oldest readback.
        void Read(AsyncGPUReadbackRequest request)
        {
            var triggered = _triggers[_first];
            _first = (_first + 1) % MaxInFlight;
            _inFlight--;
            if (!request.hasError) _newest = _clock.Now - triggered;
        }
    }
}
