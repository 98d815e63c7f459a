using Nowpose.Session;

namespace Nowpose.Unity.Session
{
    /// <summary>Computes the statistics of a session when they are read, at most once per frame.</summary>
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

        /// <summary>Marks the statistics as out of date. Call it once per frame.</summary>
        public void Expire() => _isFilled = false;
    }
}
