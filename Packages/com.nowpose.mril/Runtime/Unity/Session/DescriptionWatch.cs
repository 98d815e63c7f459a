using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Session
{
    /// <summary>Reports each description of the gateway once, because the gateway sends it again after each reconnection.</summary>
    struct DescriptionWatch
    {
        RobotModel _newest;
        UrdfHash _reported;
        string _fault;

        /// <summary>The robot that the gateway describes; null before the first description, and if an asset describes the robot.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>Processes the session's newest description.</summary>
        /// <param name="shown">The robot of the session; null for none.</param>
        /// <param name="asset">Asset that describes the robot instead of the gateway; null for none.</param>
        /// <returns>Whether <see cref="Robot"/> has changed, so that the session must restart.</returns>
        public bool Follow(CompensationSession session, RobotModel shown, RobotDescriptionAsset asset, SessionLog log)
        {
            if (IsNews(session.RobotDescriptionFault))
                log.Warn(SessionMessages.DescriptionUnusable(session.RobotDescriptionFault));
            var described = session.DescribedRobot;
            if (!IsNews(described, shown)) return false;
            if (asset != null)
            {
                log.Warn(SessionMessages.DescriptionDiffers(described.Name, asset.name));
                return false;
            }
            log.Info(SessionMessages.Description(described.Name));
            Robot = described;
            return true;
        }

        bool IsNews(RobotModel described, RobotModel shown)
        {
            if (described == null || described == _newest) return false;
            _newest = described;
            if (described.SourceHash == _reported || described.SourceHash == shown?.SourceHash) return false;
            _reported = described.SourceHash;
            return true;
        }

        bool IsNews(string fault)
        {
            if (fault == null || fault == _fault) return false;
            _fault = fault;
            return true;
        }
    }
}
