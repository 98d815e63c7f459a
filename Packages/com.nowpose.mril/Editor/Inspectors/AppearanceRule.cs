using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>
    /// Rule that a robot moved by a session, and the parts that a signal moves or switches, have a Pose Appearance, so that they look different while
    /// the pose or the signal is not current.
    /// </summary>
    sealed class AppearanceRule : IShortcomingRule
    {
        public bool IsBrokenBy(Component component) =>
            (component is RobotRig || IsOfSignal(component) && IsDrawn(component))
            && !EditorUtility.IsPersistent(component) && !IsBelow<PoseAppearance>(component) && SceneSearch.SessionOf(component) != null;

        public Shortcoming Shortcoming(Component component) => new Shortcoming(
            component is RobotRig ? ShortcomingTexts.Appearance : ShortcomingTexts.SignalAppearance, InspectorTexts.AddAppearance, Add);

        /// <summary>Sets the substitute of a new Pose Appearance, because the materials of imported models cannot fade.</summary>
        public static void Complete(PoseAppearance added)
        {
            added.Substitute = PackageAsset.Hologram.Load<Material>();
            added.Refresh();
        }

        static void Add(Object[] components)
        {
            foreach (var component in components) Complete(Undo.AddComponent<PoseAppearance>(((Component)component).gameObject));
        }

        static bool IsOfSignal(Component component) => component is CellSignal || component is ActuatedPart;

        // A signal may only raise events for objects elsewhere.
        static bool IsDrawn(Component component) => component.GetComponentInChildren<Renderer>(true) != null;

        static bool IsBelow<T>(Component component) where T : Component => component.gameObject.GetComponentInParent<T>(true) != null;
    }
}
