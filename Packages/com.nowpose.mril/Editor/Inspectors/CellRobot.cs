using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Robot;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>
    /// Puts the links of a session's robot below the rigs of its cell: those of the prefab that the URDF importer has created or, if there is none,
    /// links that the rig builds. The rigs themselves remain, because other components refer to them.
    /// </summary>
    static class CellRobot
    {
        /// <summary>Returns the rigs for the session's own robot that have another robot, or none although the links can be imported.</summary>
        public static IReadOnlyList<RobotRig> RigsWithout(MrilSession session, RobotModel model)
        {
            var isImported = PrefabOf(session.RobotAsset) != null;
            return session.gameObject.GetComponentsInChildren<RobotRig>(true)
                .Where(rig => rig.RobotNamespace.Length == 0 && !rig.HasLinksOf(model) && (isImported || OtherLinks(rig).Any()))
                .ToArray();
        }

        /// <summary>Returns the names of the objects that <see cref="Show"/> removes, with everything below them except the grippers.</summary>
        public static IEnumerable<string> RemovedFrom(IEnumerable<RobotRig> rigs) =>
            rigs.SelectMany(rig => OtherLinks(rig).Select(links => rig.name + "/" + links.name));

        /// <summary>Replaces the links below rigs. The user can undo it.</summary>
        /// <exception cref="InputException">Objects that are drawn below a rig cannot be removed.</exception>
        public static void Show(MrilSession session, RobotModel model, IEnumerable<RobotRig> rigs)
        {
            var prefab = PrefabOf(session.RobotAsset);
            var step = "Show " + session.RobotAsset.name;
            foreach (var rig in rigs)
            {
                foreach (var links in OtherLinks(rig).ToArray()) Remove(links, rig, step);
                var shown = prefab != null ? Instance(prefab, rig) : rig.BuildToStay(model, PackageAsset.Hologram.Load<Material>());
                Undo.RegisterCreatedObjectUndo(shown, step);
            }
        }

        // The prefab of an imported robot is the main object of the file that also contains the description.
        static GameObject PrefabOf(RobotDescriptionAsset description) =>
            AssetDatabase.LoadMainAssetAtPath(AssetDatabase.GetAssetPath(description)) as GameObject;

        // Everything that is drawn below the rig, except tools and other rigs.
        static IEnumerable<GameObject> OtherLinks(RobotRig rig)
        {
            for (var i = 0; i < rig.transform.childCount; i++)
            {
                var child = rig.transform.GetChild(i);
                if (RigHierarchy.IsDrawn(child)) yield return child.gameObject;
            }
        }

        // The grippers stay below the rig, where they follow the flange of the new robot.
        static void Remove(GameObject links, RobotRig rig, string step)
        {
            Unpack(links);
            foreach (var gripper in links.GetComponentsInChildren<VirtualGripper>(true).Where(IsMovable))
                Undo.SetTransformParent(gripper.transform, rig.transform, step);
            Undo.DestroyObjectImmediate(links);
        }

        // A part of a prefab instance cannot be removed in all supported versions of Unity.
        static void Unpack(GameObject part)
        {
            for (var root = RootOf(part); root != null && root != part; root = RootOf(part))
                PrefabUtility.UnpackPrefabInstance(root, PrefabUnpackMode.OutermostRoot, InteractionMode.UserAction);
        }

        static bool IsMovable(Component part) => RootOf(part.gameObject) == null || RootOf(part.gameObject) == part.gameObject;

        static GameObject RootOf(GameObject part) => PrefabUtility.GetOutermostPrefabInstanceRoot(part);

        // The rig of the cell moves the links, so the instance needs no rig and no appearance of its own.
        static GameObject Instance(GameObject prefab, RobotRig rig)
        {
            var shown = (GameObject)PrefabUtility.InstantiatePrefab(prefab);
            shown.transform.SetParent(rig.transform, worldPositionStays: false);
            Discard<PoseAppearance>(shown);
            Discard<RobotRig>(shown);
            if (rig.Shows == RigPose.Held && rig.ArmMaterial != null) Cover(shown, rig.ArmMaterial);
            return shown;
        }

        static void Discard<T>(GameObject shown) where T : Component
        {
            if (shown.TryGetComponent<T>(out var component)) Object.DestroyImmediate(component);
        }

        // A ghost has one material, by which it differs from the displayed robot.
        static void Cover(GameObject shown, Material material)
        {
            foreach (var renderer in shown.GetComponentsInChildren<Renderer>(true))
            {
                renderer.sharedMaterials = renderer.sharedMaterials.Select(_ => material).ToArray();
                PrefabUtility.RecordPrefabInstancePropertyModifications(renderer);
            }
        }
    }
}
