namespace UnityEngine;

public static class SubsystemManager
{
    public static void GetSubsystems<T>(List<T> subsystems) where T : ISubsystem
    {
        subsystems.Clear();
        if (World.Current.Gpu.Display is T display) subsystems.Add(display);
    }
}
