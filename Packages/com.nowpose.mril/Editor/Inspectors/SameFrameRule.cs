using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule that each stationary object of a session has a frame of its own. Objects with the same frame replace each other's saved place.</summary>
    sealed class SameFrameRule : IShortcomingRule
    {
        public bool IsBrokenBy(Component component) => component is StationaryObject shown && !EditorUtility.IsPersistent(shown) && OtherOf(shown) != null;

        public Shortcoming Shortcoming(Component component)
        {
            var shown = (StationaryObject)component;
            return new Shortcoming(ShortcomingTexts.SameFrame(OtherOf(shown).name, shown.Frame), null, null);
        }

        static StationaryObject OtherOf(StationaryObject shown)
        {
            var session = SceneSearch.SessionOf(shown);
            if (session == null) return null;
            return SceneSearch.All<StationaryObject>(shown)
                .FirstOrDefault(other => other != shown && other.Frame == shown.Frame && SceneSearch.SessionOf(other) == session);
        }
    }
}
