namespace UnityEngine.SubsystemsImplementation;

public abstract class SubsystemProvider
{
}

public abstract class SubsystemProvider<TSubsystem> : SubsystemProvider where TSubsystem : SubsystemWithProvider, new()
{
}
