using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule that each robot of a session is displayed by one rig. A rig without a namespace shows the session's own robot.</summary>
    sealed class SameRobotRule : IShortcomingRule
    {
        public bool IsBrokenBy(Component component) => component is RobotRig rig && !EditorUtility.IsPersistent(rig) && OtherOf(rig) != null;

        public Shortcoming Shortcoming(Component component) =>
            new Shortcoming(ShortcomingTexts.SameRobot(OtherOf((RobotRig)component).name), null, null);

        static RobotRig OtherOf(RobotRig rig)
        {
            var session = SceneSearch.SessionOf(rig);
            if (session == null || !IsDisplayed(rig)) return null;
            return SceneSearch.All<RobotRig>(rig)
                .FirstOrDefault(other => other != rig && IsDisplayed(other) && other.RobotNamespace == rig.RobotNamespace && other.IsOf(session));
        }

        static bool IsDisplayed(RobotRig rig) => rig.Shows == RigPose.Displayed && rig.enabled && rig.gameObject.activeInHierarchy;
    }
}
