namespace MixedReality.Toolkit.UX;

public class SliderEventData(float oldValue, float newValue)
{
    public float OldValue { get; private set; } = oldValue;
    public float NewValue { get; private set; } = newValue;
}
