namespace UnityEngine;

public class WaitForSecondsRealtime : CustomYieldInstruction
{
    double _until = double.NaN;

    public WaitForSecondsRealtime(float time) => waitTime = time;

    public float waitTime { get; set; }

    public override bool keepWaiting
    {
        get
        {
            if (double.IsNaN(_until)) _until = Time.realtimeSinceStartupAsDouble + waitTime;
            if (Time.realtimeSinceStartupAsDouble < _until) return true;

            Reset();
            return false;
        }
    }

    public override void Reset() => _until = double.NaN;
}
