using System;

namespace Nowpose.Unity.Rendering
{
    /// <summary>Measures the CPU time of a frame's cameras, from the start of the first camera to the end of the last.</summary>
    struct CameraTime
    {
        HeadsetTime? _begun, _ended;

        public void Begin(HeadsetTime at) => _begun ??= at;

        public void End(HeadsetTime at) => _ended = at;

        /// <summary>Returns the time of the last frame, and resets it; zero if no camera rendered.</summary>
        public TimeSpan Take()
        {
            var length = _ended - _begun;
            _begun = _ended = null;
            return length ?? TimeSpan.Zero;
        }
    }
}
