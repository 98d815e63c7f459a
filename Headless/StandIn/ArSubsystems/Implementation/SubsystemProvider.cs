namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemProvider
{
}
