using Nowpose.Session;

namespace Nowpose.Unity.Session
{
    /// <summary>Statistics of a session, computed at most once per frame and only when they are read. The object is reused.</summary>
    sealed class FrameStatistics
    {
        readonly SessionStatistics _statistics = new SessionStatistics();
        bool _isFilled;

        public SessionStatistics Of(CompensationSession session, IHeadsetClock clock)
        {
            if (!_isFilled) session.Fill(_statistics, clock.Now);
            _isFilled = true;
            return _statistics;
        }

        /// <summary>A new frame has begun.</summary>
        public void Expire() => _isFilled = false;
    }
}
