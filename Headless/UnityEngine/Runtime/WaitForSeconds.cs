namespace UnityEngine;

public sealed class WaitForSeconds : YieldInstruction
{
    public WaitForSeconds(float seconds) => Seconds = seconds;

    internal float Seconds { get; }
}
