using Nowpose.Kinematics;

namespace Nowpose.Unity
{
    /// <summary>Tells once what the gateway's description brings: the gateway sends it again after each reconnection.</summary>
    struct DescriptionWatch
    {
        RobotModel _newest;
        UrdfHash _told;
        string _fault;

        /// <summary>Whether another robot than the one shown is described, for the first time.</summary>
        /// <param name="described">Null before the gateway has described any.</param>
        /// <param name="shown">Null for none.</param>
        public bool IsNews(RobotModel described, RobotModel shown)
        {
            if (described == null || described == _newest) return false;
            _newest = described;
            if (described.SourceHash == _told || described.SourceHash == shown?.SourceHash) return false;
            _told = described.SourceHash;
            return true;
        }

        /// <summary>Whether this is a fault that was not told yet.</summary>
        /// <param name="fault">Null for none.</param>
        public bool IsNews(string fault)
        {
            if (fault == null || fault == _fault) return false;
            _fault = fault;
            return true;
        }
    }
}
