using System;
using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Editor.Setup;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor
{
    /// <summary>
    /// Lists the requirements of a project for a headset with their state and purpose. A click on a button changes the project to meet a
    /// requirement. Other buttons add the parts of a cell to the scene.
    /// </summary>
    public sealed class SetupWindow : EditorWindow
    {
        const float ButtonWidth = 260;

        /// <summary>Number of buttons per row for the parts of a cell.</summary>
        const int PartsInRow = 4;

        static readonly HeadsetPlatform[] Platforms = { HeadsetPlatform.HoloLens2, HeadsetPlatform.AndroidHeadset };
        static readonly string[] PlatformNames = { "HoloLens 2", SetupTexts.AndroidHeadset };
        static readonly string[] Signs = { "✓ ", "○ ", "✗ ", "? " };
        static readonly string[] Words = { "", "advised: ", "missing: ", "unknown: " };

        // The serialised fields keep their values when Unity reloads the scripts, for example after a package was added.
        [SerializeField] int _chosen = -1;
        [SerializeField] string _trouble = null;
        [SerializeField] string[] _advice = null;

        IProjectSettings _project;
        ProjectReview _review;
        Vector2 _scroll;
        string _activity;

        [MenuItem("Window/Nowpose/Project Setup")]
        static void Open() => GetWindow<SetupWindow>(SetupTexts.WindowTitle).minSize = new Vector2(520, 300);

        internal void Show(IProjectSettings project)
        {
            _project = project;
            _review = new ProjectReview(ProjectChecks.For(project.Platform), project, _advice);
            Latch();
        }

        void OnEnable() => Show(new UnityProjectSettings(_chosen < 0 ? OfBuildTarget() : Platforms[_chosen], _trouble));

        static HeadsetPlatform OfBuildTarget() =>
            EditorUserBuildSettings.activeBuildTarget == BuildTarget.Android ? HeadsetPlatform.AndroidHeadset : HeadsetPlatform.HoloLens2;

        void OnFocus() => Refresh();

        void OnProjectChange() => Refresh();

        void Update()
        {
            if (_project.Activity != _activity || _project.Trouble != _trouble) Refresh();
        }

        void OnGUI()
        {
            var shown = Array.IndexOf(Platforms, _project.Platform);
            var chosen = GUILayout.Toolbar(shown, PlatformNames);
            EditorGUILayout.LabelField(SetupTexts.Summary(_review.MissingCount, _project.Platform.Headset), EditorStyles.boldLabel);
            if (_activity != null) EditorGUILayout.HelpBox(_activity, MessageType.Info);
            if (_trouble != null) EditorGUILayout.HelpBox(_trouble, MessageType.Error);
            var clicked = -1;
            using (var scroll = new EditorGUILayout.ScrollViewScope(_scroll))
            {
                _scroll = scroll.scrollPosition;
                for (var i = 0; i < _review.Checks.Count; i++)
                    if (Draw(i)) clicked = i;
            }
            var again = GUILayout.Button(SetupTexts.CheckAgain);
            var part = DrawParts();

            // Executes the action after this event, because the number of controls must not change within an event, and a fix may recompile all
            // scripts.
            if (chosen != shown) EditorApplication.delayCall += () => Choose(chosen);
            else if (clicked >= 0) EditorApplication.delayCall += () => Fix(clicked);
            else if (again) EditorApplication.delayCall += Refresh;
            else if (part >= 0) EditorApplication.delayCall += () => CellMenu.Entries[part].Create(new MenuCommand(null));
        }

        /// <summary>Draws the buttons for the parts of a cell.</summary>
        /// <returns>Index of the clicked entry in <see cref="CellMenu.Entries"/>; −1 if no button was clicked.</returns>
        static int DrawParts()
        {
            var clicked = -1;
            EditorGUILayout.LabelField(SetupTexts.AddToScene, EditorStyles.boldLabel);
            for (var first = 0; first < CellMenu.Entries.Length; first += PartsInRow)
                using (new EditorGUILayout.HorizontalScope())
                    for (var i = first; i < Math.Min(first + PartsInRow, CellMenu.Entries.Length); i++)
                        if (GUILayout.Button(CellMenu.Entries[i].Name)) clicked = i;
            return clicked;
        }

        void Choose(int platform)
        {
            if (this == null) return;
            _chosen = platform;
            _advice = null;
            Show(new UnityProjectSettings(Platforms[platform]));
            Repaint();
        }

        void Fix(int check)
        {
            if (this == null) return;
            _review.Fix(check);
            Refresh();
        }

        void Refresh()
        {
            if (this == null || _review == null) return;
            _review.Refresh();
            Latch();
            Repaint();
        }

        void Latch()
        {
            _activity = _project.Activity;
            _trouble = _project.Trouble;
            _advice = _review.Advice.ToArray();
        }

        bool Draw(int index)
        {
            var check = _review.Checks[index];
            var result = _review.Results[index];
            var clicked = false;
            using (new EditorGUILayout.VerticalScope(EditorStyles.helpBox))
            {
                EditorGUILayout.LabelField(Signs[(int)result.State] + check.Title, EditorStyles.boldLabel);
                EditorGUILayout.LabelField(Words[(int)result.State] + result.Found, EditorStyles.wordWrappedLabel);
                EditorGUILayout.LabelField(check.Why, EditorStyles.wordWrappedMiniLabel);
                if (result.State != CheckState.Good && check.FixLabel != null)
                    clicked = GUILayout.Button(check.FixLabel, GUILayout.Width(ButtonWidth));
                if (_review.Advice[index] != null) EditorGUILayout.HelpBox(_review.Advice[index], MessageType.Info);
            }
            return clicked;
        }
    }
}
