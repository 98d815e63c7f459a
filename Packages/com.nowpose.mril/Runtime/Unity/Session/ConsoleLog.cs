using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Logs lines with the prefix of the package. A click on a line selects the object that is passed as the parameter context.</summary>
    static class ConsoleLog
    {
        const string Prefix = "[Nowpose] ";

        public static void Info(Object context, string message) => Debug.Log(Prefix + message, context);
        public static void Warn(Object context, string message) => Debug.LogWarning(Prefix + message, context);
        public static void Fail(Object context, string message) => Debug.LogError(Prefix + message, context);
    }
}
