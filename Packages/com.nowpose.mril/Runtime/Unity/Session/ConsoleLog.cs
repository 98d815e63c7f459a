using UnityEngine;

namespace Nowpose.Unity.Session
{
    /// <summary>Lines in the console that say where they come from. The context is what a click on the line selects.</summary>
    static class ConsoleLog
    {
        /// <summary>Before a text that is a constant it costs no allocation.</summary>
        public const string Prefix = "[Nowpose] ";

        public static void Say(Object context, string message) => Debug.Log(Prefix + message, context);
        public static void Warn(Object context, string message) => Debug.LogWarning(Prefix + message, context);
        public static void Fail(Object context, string message) => Debug.LogError(Prefix + message, context);
    }
}
