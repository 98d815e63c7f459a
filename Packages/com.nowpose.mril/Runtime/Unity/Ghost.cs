using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>Marks a second rig that shows the newest samples without compensation, for comparison.</summary>
    [AddComponentMenu("Nowpose/Ghost")]
    [RequireComponent(typeof(RobotRig))]
    [DisallowMultipleComponent]
    public sealed class Ghost : MonoBehaviour
    {
        [SerializeField, Tooltip("The rig to compare with. Empty: the rig beside this object that shows the displayed pose.")]
        RobotRig _displayed = null;

        RobotRig _own, _other;

        /// <summary>Whether the ghost is shown. A hidden ghost is inactive and needs no computing time.</summary>
        public bool Visible
        {
            get => gameObject.activeSelf;
            set => gameObject.SetActive(value);
        }

        /// <summary>
        /// Distance in metres between the tools of the ghost and of the compensated rig: the distance by which the compensation moves the tool. Null
        /// while the ghost is hidden or one of the rigs shows no robot.
        /// </summary>
        public float? GapMetres
        {
            get
            {
                if (!isActiveAndEnabled || _other == null || _own.Tool == null || _other.Tool == null) return null;
                return Vector3.Distance(_own.Tool.position, _other.Tool.position);
            }
        }

        void OnEnable()
        {
            _own = GetComponent<RobotRig>();
            _other = _displayed != null ? _displayed : DisplayedBeside(transform.parent);
            if (_other == null)
                ConsoleLog.Warn(this, ComponentMessages.GhostWithoutRig(name));
        }

        static RobotRig DisplayedBeside(Transform parent)
        {
            if (parent == null) return null;
            foreach (var rig in parent.GetComponentsInChildren<RobotRig>())
                if (rig.Shows == RigPose.Displayed) return rig;
            return null;
        }
    }
}
