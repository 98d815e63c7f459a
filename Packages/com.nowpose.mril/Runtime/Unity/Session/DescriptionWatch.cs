using Nowpose.Kinematics;

namespace Nowpose.Unity
{
    /// <summary>Tells once when the gateway describes another robot than the one shown: it says so again after each reconnection.</summary>
    struct DescriptionWatch
    {
        RobotModel _newest;
        UrdfHash _told;

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
    }
}
