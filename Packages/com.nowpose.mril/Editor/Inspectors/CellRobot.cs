using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Kinematics;
using Nowpose.Unity;
using Nowpose.Unity.Robot;
using Nowpose.Unity.Session;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

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

        // Everything that is drawn below the rig, except tools, other rigs and objects of the user.
        static IEnumerable<GameObject> OtherLinks(RobotRig rig)
        {
            for (var i = 0; i < rig.transform.childCount; i++)
            {
                var child = rig.transform.GetChild(i);
                if (!HasComponentOfPackage(child) && RigHierarchy.DrawnAt(child) != null) yield return child.gameObject;
            }
        }

        // The user's objects stay below the rig, where a gripper follows the flange of the new robot.
        static void Remove(GameObject links, RobotRig rig, string step)
        {
            var kept = AddedBelow(links.transform).ToArray();
            Unpack(links);
            // A part of another prefab instance is moved with the whole instance.
            foreach (var each in kept.Select(each => RootOf(each) is GameObject root && root != null ? root : each).Distinct())
            {
                Undo.SetTransformParent(each.transform, rig.transform, step);
                if (!each.TryGetComponent<VirtualGripper>(out _)) ConsoleLog.Warn(each, InspectorTexts.MovedToRig(each.name, rig.name));
            }
            Undo.DestroyObjectImmediate(links);
        }

        // The topmost objects that the user has added below links. A robot consists of objects without components of the package. In an instance of
        // a prefab, Unity distinguishes added objects of any kind.
        static IEnumerable<GameObject> AddedBelow(Transform links)
        {
            for (var i = 0; i < links.childCount; i++)
            {
                var child = links.GetChild(i);
                if (HasComponentOfPackage(child) || PrefabUtility.IsAddedGameObjectOverride(child.gameObject)) yield return child.gameObject;
                else
                    foreach (var each in AddedBelow(child)) yield return each;
            }
        }

        static bool HasComponentOfPackage(Transform at) => at.GetComponents<MonoBehaviour>().Any(
            each => each != null && !(each is PoseAppearance) && each.GetType().Namespace?.StartsWith("Nowpose.", StringComparison.Ordinal) == true);

        // A part of a prefab instance cannot be removed or moved in all supported versions of Unity.
        static void Unpack(GameObject part)
        {
            for (var root = RootOf(part); root != null; root = RootOf(part))
                PrefabUtility.UnpackPrefabInstance(root, PrefabUnpackMode.OutermostRoot, InteractionMode.UserAction);
        }

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
