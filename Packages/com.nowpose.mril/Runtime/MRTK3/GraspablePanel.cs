using MixedReality.Toolkit;
using MixedReality.Toolkit.SpatialManipulation;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;
using UnityEngine.XR.Interaction.Toolkit;

namespace Nowpose.Mrtk3
{
    /// <summary>Pins a panel when the wearer grasps it. A pinned panel stays in place and no longer follows the wearer.</summary>
    [AddComponentMenu("Nowpose/Graspable Panel")]
    [DisallowMultipleComponent]
    public sealed class GraspablePanel : MonoBehaviour
    {
        [SerializeField, Tooltip("The component that makes the panel follow the wearer. Empty: the one on this object.")]
        BodyFollow _follow = null;

        [SerializeField, Tooltip("The manipulator that moves the panel. Empty: the manipulator on this object.")]
        ObjectManipulator _manipulator = null;

        [SerializeField, Tooltip("Toggle that is on while the panel stays in place. Its event calls Toggle Pinned. Empty: no toggle.")]
        StatefulInteractable _pin = null;

        /// <summary>Whether the panel is pinned in place.</summary>
        public bool IsPinned => Follow != null && !Follow.enabled;

        public void TogglePinned() => SetPinned(!IsPinned);

        public void SetPinned(bool pinned)
        {
            if (Follow != null) Follow.enabled = !pinned;
        }

        // A script may pin the panel before this component is first enabled.
        BodyFollow Follow
        {
            get
            {
                if (_follow == null) TryGetComponent(out _follow);
                return _follow;
            }
        }

        void OnEnable()
        {
            if (_manipulator == null) _manipulator = GetComponent<ObjectManipulator>();
            if (Follow == null) ConsoleLog.Warn(this, Mrtk3Messages.PanelWithoutFollow(name));
            if (_manipulator == null) ConsoleLog.Warn(this, Mrtk3Messages.PanelWithoutManipulator(name));
            else _manipulator.firstSelectEntered.AddListener(Grasp);
        }

        void OnDisable()
        {
            if (_manipulator != null) _manipulator.firstSelectEntered.RemoveListener(Grasp);
        }

        void LateUpdate()
        {
            if (_pin != null && _pin.IsToggled.Active != IsPinned) _pin.ForceSetToggled(IsPinned);
        }

        void Grasp(SelectEnterEventArgs args) => SetPinned(true);
    }
}
