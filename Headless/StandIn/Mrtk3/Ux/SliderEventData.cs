namespace MixedReality.Toolkit.UX;

public class SliderEventData
{
    public SliderEventData(float oldValue, float newValue)
    {
        OldValue = oldValue;
        NewValue = newValue;
    }

    public float OldValue { get; private set; }
    public float NewValue { get; private set; }
}
