using UnityEngine;
using UnityEngine.Events;

namespace MixedReality.Toolkit.UX;

public class Slider : StatefulInteractable
{
    [SerializeField] float minValue;
    [SerializeField] float maxValue = 1;
    [SerializeField] float value = 0.5f;
    [SerializeField] bool useSliderStepDivisions;
    [SerializeField] int sliderStepDivisions = 1;
    [SerializeField] UnityEvent<SliderEventData> onValueUpdated = new();

    public float MinValue
    {
        get => minValue;
        set => minValue = Mathf.Min(value, maxValue);
    }

    public float MaxValue
    {
        get => maxValue;
        set => maxValue = Mathf.Max(minValue, value);
    }

    public float Value
    {
        get => value;
        set
        {
            if (this.value == value) return;
            var before = this.value;
            this.value = Mathf.Clamp(value, minValue, maxValue);
            onValueUpdated.Invoke(new SliderEventData(before, this.value));
        }
    }

    public bool UseSliderStepDivisions
    {
        get => useSliderStepDivisions;
        set => useSliderStepDivisions = value;
    }

    public int SliderStepDivisions
    {
        get => sliderStepDivisions;
        set => sliderStepDivisions = value;
    }

    public UnityEvent<SliderEventData> OnValueUpdated => onValueUpdated;

    protected virtual void Start() => onValueUpdated.Invoke(new SliderEventData(value, value));
}
