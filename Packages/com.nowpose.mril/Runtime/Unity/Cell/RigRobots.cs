using System.Collections.Generic;
using Nowpose.Session;

namespace Nowpose.Unity.Cell
{
    /// <summary>The robots of a session that rigs show. If two rigs show the same robot at the display time, one of them probably lacks its namespace.</summary>
    sealed class RigRobots
    {
        readonly List<RigRobot> _robots = new List<RigRobot>();

        public void Add(RigRobot robot) => _robots.Add(robot);

        public void Remove(RigRobot robot) => _robots.Remove(robot);

        /// <summary>Returns the first rig that shows a robot at the display time; null if there is none. Allocates nothing.</summary>
        /// <param name="robot">The robot, which one rig may show by its namespace and another one as the session's own robot.</param>
        public RigRobot FirstDisplayed(SessionRobot robot, CompensationSession session)
        {
            foreach (var rig in _robots)
                if (rig.IsDisplayed && rig.RobotIn(session) == robot) return rig;
            return null;
        }
    }
}
