using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Unity.Session
{
    /// <summary>Stores the properties of the display that components report, and passes them to the running session and all later sessions.</summary>
    sealed class KeptDisplay
    {
        CompensationSession _session;
        IDisplayTimeSource _timeSource;
        ReprojectionMode _reprojection;
        DepthSubmission _depth;

        public IDisplayTimeSource TimeSource
        {
            get => _timeSource;
            set
            {
                _timeSource = value;
                if (_session != null) _session.DisplayTimeSource = value;
            }
        }

        public ReprojectionMode Reprojection
        {
            get => _reprojection;
            set
            {
                _reprojection = value;
                if (_session != null) _session.Reprojection = value;
            }
        }

        public DepthSubmission DepthSubmission
        {
            get => _depth;
            set
            {
                _depth = value;
                if (_session != null) _session.DepthSubmission = value;
            }
        }

        /// <summary>Passes the stored properties to a new session.</summary>
        /// <param name="session">The new session; null if the session has ended.</param>
        public void Follow(CompensationSession session)
        {
            _session = session;
            if (session == null) return;
            session.DisplayTimeSource = _timeSource;
            session.Reprojection = _reprojection;
            session.DepthSubmission = _depth;
        }
    }
}
