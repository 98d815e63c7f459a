using UnityEngine.Events;

namespace UnityEngine;

/// <summary>Calls delegates of scripts, and logs their exceptions.</summary>
static class Callbacks
{
    internal static void Call(UnityAction call)
    {
        try
        {
            call?.Invoke();
        }
        catch (Exception e)
        {
            Debug.LogException(e);
        }
    }

    internal static void Call(Camera.CameraCallback call, Camera camera)
    {
        try
        {
            call?.Invoke(camera);
        }
        catch (Exception e)
        {
            Debug.LogException(e);
        }
    }

    internal static void Call<T>(Action<T> call, T argument)
    {
        try
        {
            call?.Invoke(argument);
        }
        catch (Exception e)
        {
            Debug.LogException(e);
        }
    }
}
