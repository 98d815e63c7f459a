using Nowpose.Anchoring;
using Nowpose.Unity.Session;
using UnityEngine;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>Logs state changes of a base anchor: as a warning if the user must act, otherwise as information.</summary>
    static class AnchorLog
    {
        public static void Log(Object anchor, BaseAnchorState state, string words, bool isWrong)
        {
            var message = "base anchor '" + anchor.name + "': " + words;
            if (state == BaseAnchorState.Moved || state == BaseAnchorState.Lost || isWrong) ConsoleLog.Warn(anchor, message);
            else ConsoleLog.Info(anchor, message);
        }
    }
}
