using System;
using Nowpose.Kinematics;

namespace Nowpose.Frames
{
    /// <summary>Finds the object that is nearest to a gripping point, within the gripper's reach.</summary>
    struct NearestObject
    {
        readonly KnownPose _hand;
        readonly double _reach;
        double _distance;
        string _name;

        /// <param name="hand">Pose of the gripping point in the world.</param>
        /// <param name="reach">Maximum distance of an object's origin from the gripping point, m.</param>
        public NearestObject(in KnownPose hand, double reach)
        {
            _hand = hand;
            _reach = reach;
            _distance = double.PositiveInfinity;
            _name = null;
            Index = -1;
            InHand = default;
        }

        /// <summary>Index of the nearest object; −1 if no object is within reach.</summary>
        public int Index { get; private set; }

        /// <summary>Pose of the nearest object relative to the gripping point.</summary>
        public KnownPose InHand { get; private set; }

        /// <summary>
        /// Compares an object with the nearest one so far. At equal distances, the name decides, so that the order of the calls has no effect.
        /// </summary>
        /// <param name="pose">Pose of the object in the world.</param>
        public void Add(int index, string name, in KnownPose pose)
        {
            if (!pose.IsKnown) return;
            var inHand = _hand.Pose.Inverse * pose.Pose;
            var distance = Math.Sqrt(inHand.X * inHand.X + inHand.Y * inHand.Y + inHand.Z * inHand.Z);
            if (distance > _reach || distance > _distance || distance == _distance && string.CompareOrdinal(name, _name) > 0) return;
            (_distance, _name, Index) = (distance, name, index);
            InHand = new KnownPose(inHand, pose.Origin < _hand.Origin ? pose.Origin : _hand.Origin);
        }
    }
}
