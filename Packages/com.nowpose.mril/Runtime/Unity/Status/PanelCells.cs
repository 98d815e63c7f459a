using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>Creates and arranges the text objects and the background of a status panel.</summary>
    /// <remarks>
    /// The unit of length is the font size, and the origin is the position of the panel. The lower edge is fixed. The rows are above it, and the
    /// message is above the rows. The height of the background fits the shown rows.
    /// </remarks>
    sealed class PanelCells
    {
        /// <summary>
        /// Position of the background's lower edge relative to the panel's position. With this value, the rows together with a bar that is 3 units
        /// high and lies below them are centred at the panel's position. If this position is 6° below the horizontal, the lower end of the bar is
        /// 13.8° below it.
        /// </summary>
        public const float LowerEdge = -7;

        const string Name = "Cells";

        /// <summary>
        /// RowHeight: distance between two rows. LineHeight: distance between two lines of the message, which is the line spacing of the font.
        /// </summary>
        const float RowHeight = 1.25f, LineHeight = 1.15f;

        const float GapBelowMessage = 0.4f;

        /// <summary>Margin: margin of the background around the text objects. Behind: distance of the background behind them.</summary>
        const float Margin = 0.75f, Behind = 0.5f;

        /// <summary>Left edges of the columns for labels, values and notes, and the right edge of the last column.</summary>
        static readonly float[] Columns = { 0, 7.4f, 17, 30 };

        readonly Transform _sheet;
        readonly TextMesh _model;
        readonly MeshRenderer _background;
        readonly PanelCell[] _labels = new PanelCell[StatusTexts.Rows];
        readonly PanelCell[] _values = new PanelCell[StatusTexts.Rows];
        readonly PanelCell[] _notes = new PanelCell[StatusTexts.Rows];

        /// <param name="panel">Parent of the text objects.</param>
        /// <param name="model">Text object that is copied for each cell.</param>
        /// <param name="background">Material of the background; null if the panel has no background.</param>
        public PanelCells(Transform panel, TextMesh model, Material background)
        {
            _model = model;
            model.gameObject.SetActive(false);
            _sheet = new GameObject(Name) { layer = panel.gameObject.layer }.transform;
            _sheet.SetParent(panel, worldPositionStays: false);
            if (background != null) _background = CreateBackground(background);
            for (var row = StatusRow.Pose; row < StatusRow.Message; row++)
            {
                _labels[(int)row] = Copy(row, 0);
                _values[(int)row] = Copy(row, 1);
                _notes[(int)row] = Copy(row, 2);
            }
            _values[(int)StatusRow.Message] = Copy(StatusRow.Message, 0);
        }

        /// <summary>Whether the text objects were destroyed.</summary>
        public bool IsDestroyed => _sheet == null;

        /// <summary>Maximum width of a line of the message.</summary>
        public static float MessageWidth => Columns[Columns.Length - 1];

        /// <summary>Maximum width of a note.</summary>
        public static float NoteWidth => Columns[3] - Columns[2];

        /// <summary>Maximum width of a value.</summary>
        public static float ValueWidth => Columns[2] - Columns[1];

        /// <summary>Removes the text objects that an earlier instance of this class has created below a panel.</summary>
        public static void RemoveFrom(Transform panel)
        {
            var left = panel.Find(Name);
            if (left == null) return;
            // Destroy takes effect at the end of the frame. Deactivates and detaches the text objects first, so that they are neither drawn nor found
            // by a search.
            left.gameObject.SetActive(false);
            left.SetParent(null, worldPositionStays: false);
            Object.Destroy(left.gameObject);
        }

        public void Show(StatusTexts texts)
        {
            for (var row = StatusRow.Pose; row <= StatusRow.Message; row++)
                Show(row, texts.IsShown(row) ? texts.LabelOf(row) : "", texts.ValueOf(row), texts.NoteOf(row));
            Arrange(texts);
            if (_background != null) _background.enabled = true;
        }

        /// <summary>Hides the text objects and the background until the next <see cref="Show(StatusTexts)"/>.</summary>
        public void Hide()
        {
            for (var row = StatusRow.Pose; row <= StatusRow.Message; row++) Show(row, "", "", "");
            if (_background != null) _background.enabled = false;
        }

        public void Destroy()
        {
            if (_sheet != null) Object.Destroy(_sheet.gameObject);
        }

        /// <summary>Sets the font size of all text objects.</summary>
        /// <param name="size">Font size, in units of the panel's transform.</param>
        public void Resize(float size) => _sheet.localScale = Vector3.one * size;

        void Show(StatusRow row, string label, string value, string note)
        {
            _labels[(int)row].Show(label);
            _values[(int)row].Show(value);
            _notes[(int)row].Show(note);
        }

        // Arranges the rows from the bottom to the top. When a row or a line of the message appears, only the upper edge of the panel moves.
        void Arrange(StatusTexts texts)
        {
            var top = LowerEdge + Margin;
            for (var row = StatusRow.Message - 1; row >= StatusRow.Pose; row--)
            {
                if (!texts.IsShown(row)) continue;
                top += RowHeight;
                _labels[(int)row].MoveTo(top);
                _values[(int)row].MoveTo(top);
                _notes[(int)row].MoveTo(top);
            }
            if (texts.IsShown(StatusRow.Message))
            {
                top += GapBelowMessage + texts.MessageLines * LineHeight;
                _values[(int)StatusRow.Message].MoveTo(top);
            }
            if (_background != null) Cover(top + Margin);
        }

        void Cover(float upperEdge)
        {
            var background = _background.transform;
            background.localPosition = new Vector3(0, (LowerEdge + upperEdge) / 2, Behind);
            background.localScale = new Vector3(Columns[Columns.Length - 1] + 2 * Margin, upperEdge - LowerEdge, 1);
        }

        MeshRenderer CreateBackground(Material material)
        {
            var background = new GameObject("Ground") { layer = _sheet.gameObject.layer };
            background.AddComponent<MeshFilter>().sharedMesh = Resources.GetBuiltinResource<Mesh>("Quad.fbx");
            var renderer = background.AddComponent<MeshRenderer>();
            renderer.sharedMaterial = material;
            background.transform.SetParent(_sheet, worldPositionStays: false);
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
            copy.transform.PlaceLocally(new Vector3(Columns[column] - Columns[Columns.Length - 1] / 2, 0, 0), Quaternion.identity);
            copy.transform.localScale = Vector3.one / LetterSize.Of(_model);
            copy.gameObject.SetActive(true);
            return new PanelCell(copy);
        }
    }
}
