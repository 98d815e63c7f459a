using System;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Unity.Messages;

namespace Nowpose.Unity.Session
{
    /// <summary>
    /// Determines the robot of a session, from an asset or from the gateway's description. Reports each description from the gateway once, because the
    /// gateway sends the same description after each reconnection.
    /// </summary>
    struct DescriptionWatch
    {
        /// <summary>Replaces the robot until the gateway has described it. This model has no joints and is not shown.</summary>
        public static readonly RobotModel NoRobot = UrdfReader.Read("<robot name='none'><link name='no robot'/></robot>", "no robot");

        (Uri Gateway, CertificatePin Pin, string Namespace) _source;
        RobotModel _newest;
        string _reported;
        string _fault;

        /// <summary>The robot as described by the gateway; null before the first description, and if an asset describes the robot.</summary>
        public RobotModel Robot { get; private set; }

        /// <summary>Returns the robot for the next session; null while it is unknown.</summary>
        /// <param name="asset">Asset that describes the robot in place of the gateway; null if there is none.</param>
        /// <param name="shown">
        /// Robot of the previous session; null while it is unknown. It is returned again for the same URDF, so that rigs stay bound to it.
        /// </param>
        /// <param name="settings">Settings of the session. Another gateway or namespace has another robot, so the known description is discarded.</param>
        /// <exception cref="InputException">The asset's URDF is invalid.</exception>
        public RobotModel ModelOf(RobotDescriptionAsset asset, RobotModel shown, SessionSettings settings)
        {
            var source = (settings.Connection.WebSocketUri, settings.Connection.Pin, settings.RobotNamespace);
            if (!source.Equals(_source)) this = new DescriptionWatch { _source = source };
            if (asset == null) return Robot;
            return shown?.SourceHash == UrdfHash.Of(asset.Urdf) ? shown : asset.Read();
        }

        /// <summary>Processes the newest description that the session has received.</summary>
        /// <param name="shown">The robot of the session; null while it is unknown.</param>
        /// <param name="asset">Asset that describes the robot in place of the gateway; null if there is none.</param>
        /// <returns>True if <see cref="Robot"/> has changed. The session must then restart.</returns>
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
