using UnityEngine.Events;

namespace UnityEngine;

/// <summary>Calls delegates of scripts, and logs their exceptions.</summary>
static class Callbacks
{
    internal static void Call(UnityAction call) => Call(call, false, (each, _) => each());

    internal static void Call(Camera.CameraCallback call, Camera camera) => Call(call, camera, (each, shown) => each(shown));

    internal static void Call<T>(Action<T> call, T argument) => Call(call, argument, (each, given) => each(given));

    // The functions capture no variables, because that would allocate in each frame.
    static void Call<TCall, T>(TCall call, T argument, Action<TCall, T> invoke) where TCall : Delegate
    {
        try
        {
            if (call != null) invoke(call, argument);
        }
        catch (Exception e)
        {
            Debug.LogException(e);
        }
    }
}
