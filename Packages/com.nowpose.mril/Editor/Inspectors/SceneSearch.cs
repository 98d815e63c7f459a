using System.Collections.Generic;
using System.Linq;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Finds components in a scene, such as the one that a reference needs if there is only one to choose.</summary>
    static class SceneSearch
    {
        /// <summary>Searches the scene or open prefab of a component for components of a type. Returns null unless there is exactly one.</summary>
        public static T Only<T>(Component component) where T : Component => OnlyOf(All<T>(component).ToArray());

        /// <summary>Returns all components of a type in the scene or open prefab of a component.</summary>
        public static IEnumerable<T> All<T>(Component component) where T : Component => RootsOf(component).SelectMany(Below<T>);

        /// <summary>
        /// Searches the scene or open prefab of a component for rigs that show the displayed pose. Returns null unless there is exactly one.
        /// </summary>
        public static RobotRig OnlyDisplayedRig(Component component) => OnlyDisplayed(RootsOf(component));

        /// <summary>Searches below an object for rigs that show the displayed pose. Returns null unless there is exactly one.</summary>
        public static RobotRig OnlyDisplayedRigBelow(GameObject above) => OnlyDisplayed(above);

        static RobotRig OnlyDisplayed(params GameObject[] roots) =>
            OnlyOf(roots.SelectMany(Below<RobotRig>).Where(rig => rig.Shows == RigPose.Displayed).ToArray());

        /// <summary>Returns the session that is assigned to a component, or else the one on its object or a parent; null if there is none.</summary>
        public static MrilSession SessionOf(Component component)
        {
            var assigned = SerialisedField.Referenced<MrilSession>(component, "_session");
            return assigned != null ? assigned : component.gameObject.GetComponentInParent<MrilSession>(true);
        }

        // A prefab asset is in no scene.
        static GameObject[] RootsOf(Component component) =>
            EditorUtility.IsPersistent(component) ? new[] { component.transform.root.gameObject } : component.gameObject.scene.GetRootGameObjects();

        static T[] Below<T>(GameObject root) => root.GetComponentsInChildren<T>(true);

        static T OnlyOf<T>(T[] found) where T : class => found.Length == 1 ? found[0] : null;
    }
}
