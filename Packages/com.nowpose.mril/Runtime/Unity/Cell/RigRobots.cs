using System;
using System.Collections.Generic;

namespace Nowpose.Unity.Cell
{
    /// <summary>The robots of a session that rigs show. If two rigs show the same robot at the display time, one of them probably lacks its namespace.</summary>
    sealed class RigRobots
    {
        readonly List<RigRobot> _robots = new List<RigRobot>();

        public void Add(RigRobot robot) => _robots.Add(robot);

        public void Remove(RigRobot robot) => _robots.Remove(robot);

        /// <summary>Returns the robot of the first rig that shows a robot at the display time; null if there is none. Allocates nothing.</summary>
        /// <param name="name">Namespace of the robot; empty for the session's own robot.</param>
        public RigRobot FirstDisplayed(string name)
        {
            foreach (var robot in _robots)
                if (robot.IsDisplayed && string.Equals(robot.Namespace, name, StringComparison.Ordinal)) return robot;
            return null;
        }
    }
}
