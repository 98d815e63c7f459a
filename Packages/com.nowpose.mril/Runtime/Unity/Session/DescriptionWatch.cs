using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Unity.Session
{
    /// <summary>Says once what the gateway's description brings: the gateway sends it again after each reconnection.</summary>
    struct DescriptionWatch
    {
        RobotModel _newest;
        UrdfHash _told;
        string _fault;

        /// <summary>The robot that the gateway describes; null before it has described any, and where an asset does.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>Takes up what the session has been sent.</summary>
        /// <param name="shown">Null for none.</param>
        /// <param name="asset">Describes the robot instead of the gateway; null for none.</param>
        /// <returns>Whether <see cref="Robot"/> is another one, which the session is not made for yet.</returns>
        public bool Follow(CompensationSession session, RobotModel shown, RobotDescriptionAsset asset, SessionLog log)
        {
            if (IsNews(session.RobotDescriptionFault))
                log.Warn("the gateway's robot description cannot be used: " + session.RobotDescriptionFault);
            var described = session.DescribedRobot;
            if (!IsNews(described, shown)) return false;
            if (asset != null)
            {
                log.Warn("the gateway describes robot '" + described.Name + "' by another URDF than asset '" + asset.name
                    + "' holds; what is shown may stand beside the real robot");
                return false;
            }
            log.Say("the gateway describes robot '" + described.Name + "'");
            Robot = described;
            return true;
        }

        bool IsNews(RobotModel described, RobotModel shown)
        {
            if (described == null || described == _newest) return false;
            _newest = described;
            if (described.SourceHash == _told || described.SourceHash == shown?.SourceHash) return false;
            _told = described.SourceHash;
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
