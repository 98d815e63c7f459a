using System.Reflection;

namespace UnityEngine;

/// <summary>Calls the messages of ScriptableObjects, and those of scripts that have an argument. Does not cache the methods, because they are rare.</summary>
static class RareMessages
{
    internal static void Call(Object target, string message, params object[] arguments)
    {
        try
        {
            ScriptType.Method(target.GetType(), message, Array.ConvertAll(arguments, argument => argument.GetType()))?.Invoke(target, arguments);
        }
        catch (TargetInvocationException e)
        {
            Debug.LogException(e.InnerException, target);
        }
    }
}
