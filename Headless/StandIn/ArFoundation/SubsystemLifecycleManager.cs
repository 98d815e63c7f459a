using UnityEngine.SubsystemsImplementation;
using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

public class SubsystemLifecycleManager<TSubsystem, TSubsystemDescriptor, TProvider> : MonoBehaviour
    where TSubsystem : SubsystemWithProvider<TSubsystem, TSubsystemDescriptor, TProvider>, new()
    where TSubsystemDescriptor : SubsystemDescriptorWithProvider<TSubsystem, TProvider>
    where TProvider : SubsystemProvider<TSubsystem>
{
    public TSubsystem subsystem { get; private set; }

    // As in Unity, the manager searches for its subsystem only here.
    protected virtual void OnEnable()
    {
        subsystem = ArDevice.Current?.Find<TSubsystem>();
        if (subsystem == null) Debug.LogWarning("No active " + typeof(TSubsystem).FullName + " is available.");
        else subsystem.Start();
    }

    protected virtual void OnDisable() => subsystem?.Stop();

    protected virtual void OnDestroy() => subsystem = null;
}
