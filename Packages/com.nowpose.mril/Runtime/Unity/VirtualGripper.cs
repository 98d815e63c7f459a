using System;
using System.Collections.Generic;
using Nowpose.Kinematics;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Makes a virtual tool follow the flange of a rig, and moves its fingers with joints of the robot.</summary>
    /// <remarks>
    /// A finger does not move if the robot has no joint with the name that is entered for the finger. If the robot has other joints beyond the flange,
    /// the <see cref="PoseAppearance"/> on this object or above it then stripes the gripper. This component does not move fingers that are links of
    /// the rig, because the rig already moves them.
    /// </remarks>
    [AddComponentMenu("Nowpose/Virtual Gripper")]
    [DisallowMultipleComponent]
    public sealed class VirtualGripper : MonoBehaviour, IShownPart, ISignalComponent
    {
        [SerializeField, Tooltip("The rig whose flange carries the gripper. Empty: the rig on a parent.")]
        RobotRig _rig = null;

        [SerializeField, Tooltip("Name of the link that carries the gripper. Empty: the last link of the arm.")]
        string _flangeLink = "";

        [SerializeField, Tooltip("Fingers of the gripper and the joints that move them.")]
        List<GripperFinger> _fingers = new List<GripperFinger>();

        readonly AppearancesOfParts _appearances = new AppearancesOfParts();
        RobotRig _source, _found;
        Transform _flange;
        FingerDrive[] _drives = Array.Empty<FingerDrive>();
        MrilSession _listedBy;
        [NonSerialized] string _fault, _title;

        /// <summary>The rig that the gripper follows; null if it follows none.</summary>
        public RobotRig Rig => _source;

        /// <summary>The link that the gripper follows; null until the rig is bound to a robot with this link.</summary>
        public Transform Flange => _flange;

        internal IReadOnlyList<GripperFinger> Fingers => _fingers;

        /// <summary>Returns the joint with which this gripper moves an object; null if it does not move it.</summary>
        internal RobotJoint JointOf(Transform finger)
        {
            foreach (var drive in _drives)
                if (drive.Finger == finger) return _source.Model.MovingJoints[drive.Joint];
            return null;
        }

        string IShownPart.Title => _title;

        string IShownPart.Fault => _fault;

        bool IShownPart.IsFaultCommon => false;

        ControlTime? IShownPart.FaultSince => null;

        string ISignalComponent.Fault => _fault;

        string ISignalComponent.FaultLabel => ObjectMessages.FingerNotMoved;

        /// <summary>
        /// Sets the field Rig, and follows this rig from now on; while this component is not active and enabled, from then on. A script can call this
        /// method at any time.
        /// </summary>
        /// <param name="rig">The rig whose flange carries the gripper; null to use the rig on a parent.</param>
        public void Mount(RobotRig rig)
        {
            _rig = rig;
            if (isActiveAndEnabled) Attach();
        }

        /// <summary>
        /// Stops following the rig until the component is enabled again, and moves the fingers to their rest poses. The component itself calls this
        /// method when it is disabled.
        /// </summary>
        public void Unmount()
        {
            Rest();
            if (_source is null) return;
            _source.Bound -= Fit;
            _source.Posed -= Follow;
            _source = null;
            _flange = null;
            _fault = null;
            List();
        }

        void OnEnable() => Attach();

        void OnDisable() => Unmount();

        // A gripper that a script has unmounted stays as it is.
        void OnTransformParentChanged()
        {
            if (ReferenceEquals(_source, _found) && this.IsBelowAnotherRig(_rig, _found)) Attach();
            else _appearances.Refresh(this);
        }

        void Attach()
        {
            Unmount();
            _source = _found = _rig != null ? _rig : GetComponentInParent<RobotRig>();
            if (_source != null)
            {
                _source.Bound += Fit;
                _source.Posed += Follow;
                if (_source.Model != null) Fit();
            }
            else ConsoleLog.Fail(this, ComponentMessages.GripperWithoutRig(name));
            _appearances.Refresh(this);
        }

        void Fit()
        {
            _flange = string.IsNullOrEmpty(_flangeLink) ? _source.Flange : _source.Link(_flangeLink);
            if (_flange == null)
                ConsoleLog.Fail(this, ComponentMessages.GripperWithoutLink(name, _source.Model.Name, _flangeLink));
            Rest();
            var drives = new List<FingerDrive>();
            var unknown = "";
            foreach (var finger in _fingers)
                if (TryDrive(finger, ref unknown, out var drive)) drives.Add(drive);
            _drives = drives.ToArray();
            _fault = null;
            if (unknown.Length > 0) Report(unknown);
            List();
        }

        // A robot without a gripper has no joints of fingers. If it has such joints, the name is wrong, and the fingers would look right but not move.
        void Report(string unknown)
        {
            var model = _source.Model;
            if (model.HasMovingJointBelow(Carrier(model)))
            {
                _fault = ComponentMessages.FingerJointUnknown(model.Name, unknown);
                ConsoleLog.Fail(this, ComponentMessages.Of("gripper", name, _fault));
            }
            else ConsoleLog.Info(this, ComponentMessages.GripperWithoutJoint(name, model.Name, unknown));
        }

        // Returns the uppermost link to which the flange is rigidly connected. The fingers of the robot may be beside the flange, as on 'flange' beside
        // 'tool0'.
        RobotLink Carrier(RobotModel model)
        {
            var entered = model.IndexOfLink(_flangeLink);
            var carrier = entered < 0 ? model.FlangeLink : model.Links[entered];
            while (carrier.ParentJoint?.Kind == JointKind.Fixed) carrier = model.Links[carrier.ParentIndex];
            return carrier;
        }

        // Only a gripper with a fault is listed, because the robot is listed already. The gripper of a ghost would be a second, identical row.
        void List()
        {
            var session = _fault == null || _source == null || _source.Shows != RigPose.Displayed ? null : _source.Session;
            if (ReferenceEquals(session, _listedBy)) return;
            if (_listedBy is object) _listedBy.Parts.Remove(this);
            _listedBy = session;
            if (session is null) return;
            _title = "gripper " + name;
            session.Parts.Add(this);
        }

        bool TryDrive(GripperFinger finger, ref string unknown, out FingerDrive drive)
        {
            drive = default;
            if (finger.Finger == null) return false;
            var index = _source.Model.IndexOfMovingJoint(finger.Joint);
            if (index < 0)
            {
                unknown += (unknown.Length > 0 ? " and no " : "") + "'" + finger.Joint + "'";
                return false;
            }
            var joint = _source.Model.MovingJoints[index];
            if (_source.Link(joint.ChildLink) == finger.Finger) return false;
            drive = new FingerDrive(index, finger.Finger, joint, _source);
            return true;
        }

        // Moves the fingers to their rest poses, from which new drives start.
        void Rest()
        {
            foreach (var drive in _drives)
                if (drive.Finger != null) drive.Move.Apply(0);
            _drives = Array.Empty<FingerDrive>();
        }

        void Follow()
        {
            List();
            if (_flange != null && !transform.IsChildOf(_flange)) transform.SetPositionAndRotation(_flange.position, _flange.rotation);
            var joints = _source.Joints;
            foreach (var drive in _drives)
                if (drive.Finger != null) drive.Move.Apply(joints[drive.Joint]);
        }

        readonly struct FingerDrive
        {
            public FingerDrive(int index, Transform finger, RobotJoint joint, RobotRig rig)
            {
                Joint = index;
                Finger = finger;
                Move = new JointDrive(finger, joint, finger.localPosition, finger.localRotation, rig.transform);
            }

            public int Joint { get; }
            public Transform Finger { get; }
            public JointDrive Move { get; }
        }
    }
}
