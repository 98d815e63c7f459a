using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Logs lines with the package's prefix. The context is the object that a click on the line selects.</summary>
    static class ConsoleLog
    {
        /// <summary>Prefix of all lines; together with a constant text it causes no allocation.</summary>
        public const string Prefix = "[Nowpose] ";

        public static void Info(Object context, string message) => Debug.Log(Prefix + message, context);
        public static void Warn(Object context, string message) => Debug.LogWarning(Prefix + message, context);
        public static void Fail(Object context, string message) => Debug.LogError(Prefix + message, context);
    }
}
