using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// Measures the time from the trigger of a render job until the program detects that the GPU has finished it: a readback that is
    /// requested after the job completes after it.
    /// </summary>
    /// <remarks>The engine checks for finished readbacks once a frame, so the resolution of the times is one frame.</remarks>
    sealed class GpuCompletion
    {
        /// <summary>Maximum readbacks in progress, more than a GPU queues frames; further frames are not measured.</summary>
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

        /// <summary>Reports that a render job was submitted to the GPU.</summary>
        public void Submitted(HeadsetTime triggered)
        {
            if (_inFlight == MaxInFlight || !SystemInfo.supportsAsyncGPUReadback) return;
            if (_texture == null) _texture = Uploaded();
            _triggers[(_first + _inFlight++) % MaxInFlight] = triggered;
            AsyncGPUReadback.Request(_texture, 0, _onRead);
        }

        /// <summary>Releases the texture. Readbacks in progress may still complete; their times are ignored.</summary>
        public void Release()
        {
            if (_texture != null) Object.Destroy(_texture);
            _texture = null;
        }

        // Without the upload, the texture might not exist on the GPU and could not be read.
        static Texture2D Uploaded()
        {
            var texture = new Texture2D(1, 1) { hideFlags = HideFlags.HideAndDontSave };
            texture.Apply();
            return texture;
        }

        // A GPU works in order, so the oldest request is complete.
        void Read(AsyncGPUReadbackRequest request)
        {
            var triggered = _triggers[_first];
            _first = (_first + 1) % MaxInFlight;
            _inFlight--;
            if (!request.hasError) _newest = _clock.Now - triggered;
        }
    }
}
