using System;

namespace Nowpose.Unity.Rendering
{
    /// <summary>The processor's time on a frame's cameras: from the first one's beginning to the last one's end.</summary>
    struct CameraTime
    {
        HeadsetTime? _begun, _ended;

        public void Begin(HeadsetTime at) => _begun ??= at;

        public void End(HeadsetTime at) => _ended = at;

        /// <summary>The time of the frame that has ended, for the next to begin; zero when no camera rendered.</summary>
        public TimeSpan Take()
        {
            var length = _ended - _begun;
            _begun = _ended = null;
            return length ?? TimeSpan.Zero;
        }
    }
}
