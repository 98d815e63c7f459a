using UnityEngine;
using UnityEngine.Events;
using UnityEngine.XR.Interaction.Toolkit;

namespace MixedReality.Toolkit;

/// <summary>Raises its click event when it is released. Toggles its state if its mode is Toggle.</summary>
public class StatefulInteractable : MRTKBaseInteractable
{
    [SerializeField] bool allowSelectByVoice = true;
    [SerializeField] string speechRecognitionKeyword = "select";

    [field: SerializeField] public ToggleType ToggleMode { get; set; }

    [field: SerializeField] public bool VoiceRequiresFocus { get; set; } = true;

    [field: SerializeField] public TimedFlag IsToggled { get; private set; } = new();

    [field: SerializeField] public UnityEvent OnClicked { get; private set; } = new();

    /// <summary>Throws before the first <see cref="Awake"/>, as in MRTK3 core 3.0.</summary>
    public bool AllowSelectByVoice
    {
        get => allowSelectByVoice;
        set
        {
            if (value == allowSelectByVoice) return;
            interactionManager.UnregisterInteractable(this);
            allowSelectByVoice = value;
            interactionManager.RegisterInteractable(this);
        }
    }

    internal string SpeechRecognitionKeyword => speechRecognitionKeyword;

    public void ForceSetToggled(bool active) => IsToggled.Active = active;

    protected override void Awake()
    {
        base.Awake();
        lastSelectExited.AddListener(Click);
    }

    void Click(SelectExitEventArgs args)
    {
        if (ToggleMode == ToggleType.Toggle || (ToggleMode == ToggleType.OneWayToggle && !IsToggled.Active)) IsToggled.Active = !IsToggled.Active;
        OnClicked.Invoke();
    }

    public enum ToggleType
    {
        Button,
        Toggle,
        OneWayToggle,
    }
}
