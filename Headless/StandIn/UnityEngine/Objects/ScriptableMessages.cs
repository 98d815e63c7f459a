using System;
using System.Reflection;

namespace UnityEngine;

/// <summary>Calls the messages of ScriptableObjects. Does not cache the methods, because these messages are rare.</summary>
static class ScriptableMessages
{
    const BindingFlags Declared = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    internal static void Call(ScriptableObject target, string message)
    {
        for (var type = target.GetType(); type != typeof(ScriptableObject) && type != null; type = type.BaseType)
        {
            var method = type.GetMethod(message, Declared, null, Type.EmptyTypes, null);
            if (method == null) continue;

            try
            {
                method.Invoke(target, null);
            }
            catch (TargetInvocationException e)
            {
                Debug.LogException(e.InnerException, target);
            }

            return;
        }
    }
}
