using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Rendering
{
    /// <summary>
    /// Measures from the trigger of a render job until the program learns that the GPU has finished it: a readback that is
    /// asked for behind the job is done after it.
    /// </summary>
    /// <remarks>The engine looks for finished readbacks once a frame, so the times come in steps of frames.</remarks>
    sealed class GpuCompletion
    {
        /// <summary>More frames than a GPU lets wait; while so many wait, further ones go unmeasured.</summary>
        const int MostInFlight = 4;

        readonly IHeadsetClock _clock;
        readonly Action<AsyncGPUReadbackRequest> _onRead;
        readonly HeadsetTime[] _triggers = new HeadsetTime[MostInFlight];
        Texture2D _texture;
        TimeSpan _newest;
        int _first, _inFlight;

        public GpuCompletion(IHeadsetClock clock)
        {
            _clock = clock;
            _onRead = Read;
        }

        /// <summary>The newest time that was measured since the last call; zero when none was.</summary>
        public TimeSpan Take()
        {
            var newest = _newest;
            _newest = TimeSpan.Zero;
            return newest;
        }

        /// <summary>A render job has been handed to the GPU.</summary>
        public void Submitted(HeadsetTime triggered)
        {
            if (_inFlight == MostInFlight || !SystemInfo.supportsAsyncGPUReadback) return;
            if (_texture == null) _texture = Uploaded();
            _triggers[(_first + _inFlight++) % MostInFlight] = triggered;
            AsyncGPUReadback.Request(_texture, 0, _onRead);
        }

        /// <summary>Readbacks that are under way may still end; nobody asks for their times.</summary>
        public void Release()
        {
            if (_texture != null) Object.Destroy(_texture);
            _texture = null;
        }

        // A texture that was never uploaded need not be there for the GPU to read.
        static Texture2D Uploaded()
        {
            var texture = new Texture2D(1, 1) { hideFlags = HideFlags.HideAndDontSave };
            texture.Apply();
            return texture;
        }

        // A GPU works in order: it is the oldest request that is done.
        void Read(AsyncGPUReadbackRequest request)
        {
            var triggered = _triggers[_first];
            _first = (_first + 1) % MostInFlight;
            _inFlight--;
            if (!request.hasError) _newest = _clock.Now - triggered;
        }
    }
}
