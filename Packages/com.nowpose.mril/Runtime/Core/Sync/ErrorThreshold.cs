using System;

namespace Nowpose.Sync
{
    /// <summary>Upper limit of an error with hysteresis, so that a state that depends on the limit does not flicker.</summary>
    sealed class ErrorThreshold
    {
        /// <summary>Fraction of the limit to which an error must fall before it is admitted again, after it has exceeded the limit.</summary>
        const double ReturnShare = 0.75;

        readonly TimeSpan _limit;
        bool _admits, _hasAdmitted;

        public ErrorThreshold(TimeSpan limit) => _limit = limit;

        public void Reset() => _admits = _hasAdmitted = false;

        public bool Admits(TimeSpan error)
        {
            var limit = _admits || !_hasAdmitted ? _limit.Ticks : ReturnShare * _limit.Ticks;
            _admits = error.Ticks <= limit;
            _hasAdmitted |= _admits;
            return _admits;
        }
    }
}
