using System;
using System.Globalization;
using MixedReality.Toolkit;
using MixedReality.Toolkit.UX;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Mrtk3
{
    /// <summary>Updates the toggles and sliders of an MRTK3 menu in each frame, so they show the current state of the cell.</summary>
    /// <remarks>
    /// The events of the buttons call <see cref="CellActions"/> directly. The events of the sliders call this component, which passes the
    /// values to <see cref="CellActions"/>.
    /// </remarks>
    [AddComponentMenu("Nowpose/Headset Menu")]
    [DisallowMultipleComponent]
    public sealed class HeadsetMenu : MonoBehaviour
    {
        [SerializeField, Tooltip("The actions that the menu calls. Empty: the actions on this object or a parent.")]
        CellActions _actions = null;

        [SerializeField, Tooltip("Toggle that connects the session. Empty: no toggle.")]
        StatefulInteractable _connect = null;

        [SerializeField, Tooltip("Toggle that shows the ghost. Empty: no toggle.")]
        StatefulInteractable _ghost = null;

        [SerializeField, Tooltip("Toggle that hides objects behind the real arm. Empty: no toggle.")]
        StatefulInteractable _occlusion = null;

        [SerializeField, Tooltip("Toggle that shows the status panel. Empty: no toggle.")]
        StatefulInteractable _panel = null;

        [SerializeField, Tooltip("Slider that sets the gripper's opacity, 0 to 1. Empty: no slider.")]
        Slider _opacity = null;

        [SerializeField, Tooltip("Text Mesh that shows the opacity. Empty: none.")]
        TextMesh _opacityWords = null;

        [SerializeField, Tooltip("Slider that sets the correction of L_visu in ms. Empty: no slider.")]
        Slider _nudge = null;

        [SerializeField, Tooltip("Text Mesh that shows the correction of L_visu. Empty: none.")]
        TextMesh _nudgeWords = null;

        int _shownOpacity = int.MinValue, _shownNudge = int.MinValue;
        bool _isShowing;

        /// <summary>Sets the gripper's opacity. The event of the opacity slider must call this method.</summary>
        public void SlideOpacity(SliderEventData data)
        {
            if (IsUsers(data)) _actions.SetOpacity(data.NewValue);
        }

        /// <summary>Sets the correction of L_visu. The event of the nudge slider must call this method.</summary>
        public void SlideNudge(SliderEventData data)
        {
            if (IsUsers(data)) _actions.SetNudgeMs(data.NewValue);
        }

        // A slider also raises its event when it starts, and when this component sets its value. Returns true only for a change by the user.
        bool IsUsers(SliderEventData data) => _actions != null && !_isShowing && data.NewValue != data.OldValue;

        void OnEnable()
        {
            if (_actions == null) _actions = GetComponentInParent<CellActions>();
            if (_actions == null) ConsoleLog.Warn(this, Mrtk3Messages.MenuWithoutActions(name));
        }

        void LateUpdate()
        {
            if (_actions == null) return;
            Show(_connect, _actions.IsConnecting);
            Show(_ghost, _actions.IsGhostShown);
            Show(_occlusion, _actions.IsOcclusionOn);
            Show(_panel, _actions.IsPanelShown);
            Show(_opacity, _actions.Opacity);
            Show(_nudge, _actions.NudgeMs);
            ShowOpacity((int)Math.Round(100 * _actions.Opacity));
            ShowNudge(_actions.IsNudgeIdle ? int.MaxValue : (int)Math.Round(10 * _actions.NudgeMs));
        }

        // A toggle changes its own state when it is pressed. If the action failed, this method restores the previous state.
        static void Show(StatefulInteractable toggle, bool isOn)
        {
            if (toggle != null && toggle.IsToggled.Active != isOn) toggle.ForceSetToggled(isOn);
        }

        void Show(Slider slider, float value)
        {
            if (slider == null) return;
            var shown = Mathf.Clamp(value, slider.MinValue, slider.MaxValue);
            if (slider.Value == shown) return;
            _isShowing = true;
            try
            {
                slider.Value = shown;
            }
            finally
            {
                // Another listener of the slider's event may throw.
                _isShowing = false;
            }
        }

        void ShowOpacity(int percent)
        {
            if (_opacityWords == null || percent == _shownOpacity) return;
            _shownOpacity = percent;
            _opacityWords.text = string.Format(CultureInfo.InvariantCulture, "Gripper {0} %", percent);
        }

        /// <param name="tenths">Nudge in units of 0.1 ms; <see cref="int.MaxValue"/> if the nudge has no effect.</param>
        void ShowNudge(int tenths)
        {
            if (_nudgeWords == null || tenths == _shownNudge) return;
            _shownNudge = tenths;
            _nudgeWords.text = tenths == int.MaxValue
                ? Mrtk3Messages.VisuByRuntime
                : string.Format(CultureInfo.InvariantCulture, "L_visu {0:+0.0;-0.0;0.0} ms", tenths / 10.0);
        }
    }
}
