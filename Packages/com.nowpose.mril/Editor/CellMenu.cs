using System;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Session;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Nowpose.Editor
{
    /// <summary>
    /// The menu GameObject > Nowpose. Its entries add prefabs of the package, or objects with components of the package, to the scene. The
    /// set-up window has the same entries.
    /// </summary>
    static class CellMenu
    {
        const string Folder = "GameObject/Nowpose/";

        // This priority places the entries between Create Empty and the first group of Unity's own entries.
        const int Priority = 10;

        /// <summary>Names and actions of the menu's entries.</summary>
        internal static readonly (string Name, Action<MenuCommand> Create)[] Entries =
        {
            ("Robot Cell", RobotCell), ("Robot Cell UR5", RobotCellUr5), (SetupTexts.AnyRobotCell, RobotCellAny),
            ("Virtual Gripper", VirtualGripper), ("Another youBot", AnotherYoubot), ("Another Robot", AnotherRobot),
            ("Tracked Object", TrackedObject), ("Stationary Object", StationaryObject), ("Signal", Signal), ("Actuated Part", ActuatedPart),
            ("Grip by Reach", GripByReach), ("Planned Path", PlannedPath),
        };

        [MenuItem(Folder + "Robot Cell", false, Priority)]
        static void RobotCell(MenuCommand command) => PlaceCell(PackageAsset.RobotCell, command);

        [MenuItem(Folder + "Robot Cell UR5", false, Priority)]
        static void RobotCellUr5(MenuCommand command) => PlaceCell(PackageAsset.RobotCellUr5, command);

        [MenuItem(Folder + SetupTexts.AnyRobotCell, false, Priority)]
        static void RobotCellAny(MenuCommand command) => PlaceCell(PackageAsset.RobotCellAny, command);

        [MenuItem(Folder + "Virtual Gripper", false, Priority)]
        static void VirtualGripper(MenuCommand command) => PlacePart(PackageAsset.VirtualGripper, command, RigFor);

        // Below the Base Anchor of a cell, the robot is in the session of this cell.
        [MenuItem(Folder + "Another youBot", false, Priority)]
        static void AnotherYoubot(MenuCommand command) => PlacePart(PackageAsset.Robot, command);

        [MenuItem(Folder + "Tracked Object", false, Priority)]
        static void TrackedObject(MenuCommand command) => CreateOnce<TrackedObject>("Tracked Object", command, AddAppearance);

        [MenuItem(Folder + "Stationary Object", false, Priority)]
        static void StationaryObject(MenuCommand command) => CreateOnce<StationaryObject>("Stationary Object", command, AddAppearance);

        [MenuItem(Folder + "Signal", false, Priority)]
        static void Signal(MenuCommand command) => CreateOnce<CellSignal>("Signal", command, AddAppearance);

        [MenuItem(Folder + "Actuated Part", false, Priority)]
        static void ActuatedPart(MenuCommand command) => CreateOnce<ActuatedPart>("Actuated Part", command, AddAppearance);

        [MenuItem(Folder + "Grip by Reach", false, Priority)]
        static void GripByReach(MenuCommand command) => CreateOnce<GripByReach>("Grip by Reach", command, parentFor: RigFor);

        [MenuItem(Folder + "Planned Path", false, Priority)]
        static void PlannedPath(MenuCommand command) => CreateOnce<PlannedPath>(
            "Planned Path", command, path => path.GetComponent<LineRenderer>().sharedMaterial = Hologram, RigFor);

        // A robot that is not current must look different, so it needs a Pose Appearance and a material that can fade.
        [MenuItem(Folder + "Another Robot", false, Priority)]
        static void AnotherRobot(MenuCommand command) => CreateOnce<RobotRig>("Robot", command, rig =>
        {
            AddLabel(rig.gameObject.AddComponent<PoseAppearance>());
            var serialized = new SerializedObject(rig);
            serialized.FindProperty("_armMaterial").objectReferenceValue = Hologram;
            serialized.FindProperty("_toolMaterial").objectReferenceValue = Hologram;
            serialized.ApplyModifiedProperties();
        });

        static Material Hologram => PackageAsset.Hologram.Load<Material>();

        // A cell has no parent: below another cell, its parts could use the session of that cell, and below a camera, it would follow the head.
        static void PlaceCell(PackageAsset prefab, MenuCommand command)
        {
            if (IsOnce(command)) Place(prefab, null);
        }

        /// <param name="parentFor">Returns the parent of the new object for the selected object; null to use the selected object.</param>
        static void PlacePart(PackageAsset prefab, MenuCommand command, Func<GameObject, GameObject> parentFor = null)
        {
            if (IsOnce(command)) Place(prefab, ParentOf(parentFor));
        }

        /// <param name="setUp">Completes the new component; null if its default values are complete.</param>
        /// <param name="parentFor">Returns the parent of the new object for the selected object; null to use the selected object.</param>
        static void CreateOnce<T>(string name, MenuCommand command, Action<T> setUp = null, Func<GameObject, GameObject> parentFor = null)
            where T : MonoBehaviour
        {
            if (!IsOnce(command)) return;
            var parent = ParentOf(parentFor);
            var made = new GameObject(name).AddComponent<T>();
            Put(made.gameObject, parent, () =>
            {
                // The name of an object is also that of its frame or signal, if none is entered.
                GameObjectUtility.EnsureUniqueNameForSibling(made.gameObject);
                setUp?.Invoke(made);
            });
        }

        // What is not current must look different. An appearance above the object also applies to it.
        static void AddAppearance(MonoBehaviour made)
        {
            if (!made.TryGetComponent<PoseAppearance>(out var appearance))
            {
                if (made.gameObject.GetComponentInParent<PoseAppearance>(true) != null) return;
                appearance = made.gameObject.AddComponent<PoseAppearance>();
            }
            AppearanceRule.Complete(appearance);
            AddLabel(appearance);
        }

        static void AddLabel(PoseAppearance appearance)
        {
            var asset = PackageAsset.PoseLabel.Load<GameObject>();
            if (asset == null) return;
            var label = (GameObject)PrefabUtility.InstantiatePrefab(asset);
            label.transform.SetParent(appearance.transform, worldPositionStays: false);
            SerialisedField.Write(appearance, "_words", field => field.objectReferenceValue = label.GetComponent<TextMesh>());
        }

        static GameObject ParentOf(Func<GameObject, GameObject> parentFor)
        {
            var selected = SelectedInScene();
            return parentFor == null ? selected : parentFor(selected);
        }

        // A component that needs a rig searches for it on its parents, so its object must not be beside the robot.
        static GameObject RigFor(GameObject selected)
        {
            if (selected == null || selected.GetComponentInParent<RobotRig>(true) != null) return selected;
            var rig = SceneSearch.OnlyDisplayedRigBelow(selected);
            return rig != null ? rig.gameObject : selected;
        }

        // Unity calls a menu item of the Hierarchy once for each selected object. Only the call for the active object creates something.
        static bool IsOnce(MenuCommand command) => command.context == null || command.context == Selection.activeObject;

        // The context of a menu command is null for the menu bar, which therefore needs the selection. In the Hierarchy, both are the same object.
        // An asset cannot be the parent of a new object.
        static GameObject SelectedInScene()
        {
            var selected = Selection.activeObject as GameObject;
            return selected != null && !EditorUtility.IsPersistent(selected) ? selected : null;
        }

        /// <summary>Adds an instance of a prefab to the scene.</summary>
        /// <param name="parent">Parent of the instance; null to add it without a parent.</param>
        /// <returns>The new instance; null if the prefab is missing.</returns>
        internal static GameObject Place(PackageAsset prefab, GameObject parent)
        {
            var asset = prefab.Load<GameObject>();
            if (asset == null)
            {
                ConsoleLog.Fail(null, SetupTexts.PrefabMissing(prefab.Name, prefab.Guid));
                return null;
            }
            return Put((GameObject)PrefabUtility.InstantiatePrefab(asset), parent);
        }

        /// <summary>Puts a new object at its parent, and selects it. The user can undo it.</summary>
        /// <param name="setUp">Completes the instance when it has its parent; null if it is complete.</param>
        internal static GameObject Put(GameObject instance, GameObject parent, Action setUp = null)
        {
            StageUtility.PlaceGameObjectInCurrentStage(instance);
            GameObjectUtility.SetParentAndAlign(instance, parent);
            setUp?.Invoke();
            Undo.RegisterCreatedObjectUndo(instance, "Create " + instance.name);
            Selection.activeObject = instance;
            return instance;
        }
    }
}
