using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Session;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>
    /// The rigs that carry a rig on a link, such as a vehicle with an arm, and their planned motion. Does not allocate in a frame.
    /// </summary>
    sealed class CarryingRigs
    {
        readonly List<(RobotRig Rig, Transform Link, int Index)> _carriers = new List<(RobotRig, Transform, int)>();

        /// <summary>Finds the rigs whose joints move the base of a rig in the displayed frame.</summary>
        /// <param name="rig">A rig whose robot is known.</param>
        /// <returns>Reason why the motion of the base is unknown, in one line; null if it is known.</returns>
        public string Find(RobotRig rig)
        {
            _carriers.Clear();
            while (true)
            {
                var robot = rig.Robot;
                if (robot.HasRootFrame) return robot.HasFixedRootFrame ? null : PlannedPathMessages.BaseMoves;
                if (!TryFindAbove(rig, out var carrier, out var isFixed)) return isFixed ? null : PlannedPathMessages.BaseMoves;
                // Without a binding, no link moves. Another session has another clock.
                if (!carrier.IsFollowing || carrier.Session != rig.Session || carrier.Robot == null) return PlannedPathMessages.CarrierUnknown;
                var link = carrier.LinkAbove(rig.transform, out var place);
                if (link >= 0 && carrier.Robot.IsMovedByJoints(link))
                {
                    if (carrier.Shows != RigPose.Displayed || carrier.Robot.Frame.SettledState != PoseState.Current)
                        return PlannedPathMessages.CarrierNotCurrent;
                    _carriers.Add((carrier, place, link));
                }
                rig = carrier;
            }
        }

        /// <summary>Moves a point with the planned motion of the rigs from the displayed frame to a later time.</summary>
        /// <param name="point">Point in Unity's world that would be at rest without this motion.</param>
        /// <returns>False if a rig has no plan for that time.</returns>
        public bool TryMove(ControlTime at, ref Vector3 point)
        {
            foreach (var (rig, link, index) in _carriers)
            {
                if (!rig.Robot.TryPlan(index, at, out var planned)) return false;
                var pose = UnityFrame.ToUnity(planned);
                point = rig.transform.TransformPoint(pose.Position() + pose.Rotation() * link.InverseTransformPoint(point));
            }
            return true;
        }

        // Without a frame of its own, a robot stands on the object or robot above its rig.
        static bool TryFindAbove(RobotRig rig, out RobotRig carrier, out bool isFixed)
        {
            (carrier, isFixed) = (null, true);
            for (var at = rig.transform; at != null; at = at.parent)
            {
                if (at.TryGetComponent<ICellObject>(out var shown))
                {
                    isFixed = shown.IsFixed;
                    return false;
                }
                if (at.TryGetComponent(out carrier) && carrier != rig) return true;
            }
            return false;
        }
    }
}
