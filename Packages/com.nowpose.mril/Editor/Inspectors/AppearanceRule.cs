using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Rule that a robot moved by a session has a Pose Appearance, so that a pose that is not current looks different.</summary>
    sealed class AppearanceRule : IShortcomingRule
    {
        public bool IsBrokenBy(Component component) =>
            component is RobotRig && !EditorUtility.IsPersistent(component) && !IsBelow<PoseAppearance>(component) && HasSession(component);

        public Shortcoming Shortcoming(Component component) =>
            new Shortcoming(ShortcomingTexts.Appearance, InspectorTexts.AddAppearance, Add);

        // Materials of imported models cannot fade, so the parts need a substitute.
        static void Add(Object[] rigs)
        {
            foreach (var rig in rigs)
            {
                var added = Undo.AddComponent<PoseAppearance>(((Component)rig).gameObject);
                added.Substitute = PackageAsset.Hologram.Load<Material>();
                added.Refresh();
            }
        }

        static bool HasSession(Component rig)
        {
            using (var serialised = new SerializedObject(rig))
                return serialised.FindProperty("_session").objectReferenceValue != null || IsBelow<MrilSession>(rig);
        }

        static bool IsBelow<T>(Component rig) where T : Component => rig.gameObject.GetComponentInParent<T>(true) != null;
    }
}
