using System;

namespace Nowpose.Latency.Reprojection
{
    /// <summary>Follows whether depth is submitted; a change counts once it has lasted a second.</summary>
    /// <remarks>So a scene that changes its camera reports nothing. Allocates nothing; not thread-safe.</remarks>
    sealed class DepthSubmissionWatch
    {
        static readonly TimeSpan Lasting = TimeSpan.FromSeconds(1);

        DepthSubmission _observed;
        HeadsetTime? _since;

        public DepthSubmission State { get; private set; }

        /// <param name="now">Not earlier than the one before.</param>
        /// <returns>Whether <see cref="State"/> has changed.</returns>
        public bool Follow(HeadsetTime now, DepthSubmission observed)
        {
            if (observed != _observed || _since == null) (_observed, _since) = (observed, now);
            if (observed == State || now - _since < Lasting) return false;
            State = observed;
            return true;
        }

        /// <summary>Nothing is observed any more.</summary>
        public void Reset()
        {
            _since = null;
            State = DepthSubmission.Unknown;
        }
    }
}
