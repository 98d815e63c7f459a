using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>The texts of a status panel in their places. One unit is the font's size.</summary>
    sealed class PanelCells
    {
        const string Name = "Cells";

        const float RowHeight = 1.35f;

        /// <summary>Of the ground: beyond the outermost letters, and behind all of them.</summary>
        const float Margin = 1, Behind = 0.5f;

        /// <summary>Left edges of labels, values and notes, and the right edge of all.</summary>
        static readonly float[] Columns = { 0, 8, 17, 29 };

        readonly Transform _sheet;
        readonly TextMesh _model;
        readonly MeshRenderer _ground;
        readonly PanelCell[] _labels = new PanelCell[StatusTexts.Rows];
        readonly PanelCell[] _values = new PanelCell[StatusTexts.Rows];
        readonly PanelCell[] _notes = new PanelCell[StatusTexts.Rows];

        /// <param name="panel">What they hang below.</param>
        /// <param name="model">What they are copies of.</param>
        /// <param name="ground">Material of what is behind them; null for nothing.</param>
        public PanelCells(Transform panel, TextMesh model, Material ground)
        {
            _model = model;
            model.gameObject.SetActive(false);
            _sheet = new GameObject(Name) { layer = panel.gameObject.layer }.transform;
            _sheet.SetParent(panel, worldPositionStays: false);
            if (ground != null) _ground = Lay(ground);
            for (var row = StatusRow.Pose; row < StatusRow.Message; row++)
            {
                _labels[(int)row] = Copy(row, 0);
                _values[(int)row] = Copy(row, 1);
                _notes[(int)row] = Copy(row, 2);
            }
            _values[(int)StatusRow.Message] = Copy(StatusRow.Message, 0);
        }

        /// <summary>Takes away those that another has made there.</summary>
        public static void RemoveFrom(Transform panel)
        {
            var left = panel.Find(Name);
            if (left == null) return;
            // Destroyed at the end of the frame only.
            left.gameObject.SetActive(false);
            left.SetParent(null, worldPositionStays: false);
            Object.Destroy(left.gameObject);
        }

        public void Show(StatusTexts texts)
        {
            for (var row = StatusRow.Pose; row <= StatusRow.Message; row++)
                Show(row, StatusTexts.LabelOf(row), texts.ValueOf(row), texts.NoteOf(row));
            if (_ground != null) _ground.enabled = true;
        }

        /// <summary>Until the next <see cref="Show(StatusTexts)"/>.</summary>
        public void Hide()
        {
            for (var row = StatusRow.Pose; row <= StatusRow.Message; row++) Show(row, "", "", "");
            if (_ground != null) _ground.enabled = false;
        }

        public void Destroy()
        {
            if (_sheet != null) Object.Destroy(_sheet.gameObject);
        }

        /// <param name="size">Of the font, metres.</param>
        public void Resize(float size) => ReadingDistance.Scale(_sheet, size);

        void Show(StatusRow row, string label, string value, string note)
        {
            _labels[(int)row].Show(label);
            _values[(int)row].Show(value);
            _notes[(int)row].Show(note);
        }

        MeshRenderer Lay(Material material)
        {
            var ground = new GameObject("Ground") { layer = _sheet.gameObject.layer };
            ground.AddComponent<MeshFilter>().sharedMesh = Resources.GetBuiltinResource<Mesh>("Quad.fbx");
            var renderer = ground.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = material;
            ground.transform.SetParent(_sheet, worldPositionStays: false);
            ground.transform.localPosition = new Vector3(0, 0, Behind);
            ground.transform.localScale = new Vector3(
                Columns[Columns.Length - 1] + 2 * Margin, StatusTexts.Rows * RowHeight + 2 * Margin, 1);
            return renderer;
        }

        PanelCell Copy(StatusRow row, int column)
        {
            var copy = Object.Instantiate(_model, _sheet);
            copy.name = row + " " + column;
            copy.anchor = TextAnchor.UpperLeft;
            copy.alignment = TextAlignment.Left;
            copy.richText = false;
            copy.text = "";
            copy.transform.PlaceLocally(
                new Vector3(Columns[column] - Columns[Columns.Length - 1] / 2, (StatusTexts.Rows / 2f - (int)row) * RowHeight, 0),
                Quaternion.identity);
            copy.transform.localScale = Vector3.one / LetterSize.Of(_model);
            copy.gameObject.SetActive(true);
            return new PanelCell(copy);
        }
    }
}
