using System;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity.Status
{
    public class ReadingDistanceTests
    {
        readonly SceneObjects _objects = new SceneObjects();

        [TearDown]
        public void Clear() => _objects.Destroy();

        [Test]
        public void Update_ViewerMoves_KeepsTheLettersAboveHalfADegree()
        {
            var random = new System.Random(3);
            var distance = new ReadingDistance();
            var (metres, changes) = (1.0, 0);
            for (var i = 0; i < 10_000; i++)
            {
                metres = Math.Min(8, Math.Max(0.3, metres + 0.02 * (random.NextDouble() - 0.5)));
                if (distance.Update((float)metres)) changes++;
                // The height of a capital letter of Liberation Sans is 1409/2048 of the font size.
                var height = 1409 / 2048.0 * LetterSize.At(distance.Metres);

                Assert.That(2 * Math.Atan(height / 2 / metres) * 180 / Math.PI, Is.InRange(0.4999, 0.5 * 1.51), "seed 3, step " + i);
            }

            Assert.That(changes, Is.LessThan(60));
        }

        [Test]
        public void LetterSizeAt_OneMetre_CapitalLettersSpanHalfADegree()
        {
            Assert.That(LetterSize.At(1) * 1409 / 2048, Is.EqualTo(0.008727).Within(1e-5));
        }

        [TestCase(64, 1, 6.4f)]
        [TestCase(100, 0.01f, 0.1f)]
        [TestCase(0, 1, 1.3f)]
        public void LetterSizeOf_Text_IsATenthOfFontSizeTimesCharacterSize(int points, float characterSize, float expected)
        {
            var text = _objects.New<TextMesh>("text");
            text.fontSize = points;
            text.characterSize = characterSize;

            Assert.That(LetterSize.Of(text), Is.EqualTo(expected).Within(1e-5));
        }

        [TestCase(1)]
        [TestCase(0.01f)]
        [TestCase(7)]
        public void Face_TextBelowScaledObjects_HasItsSizeInTheWorldAndFacesTheViewer(float scale)
        {
            var above = _objects.New("above");
            above.localScale = Vector3.one * scale;
            var text = _objects.New<TextMesh>("text", above);
            text.fontSize = 64;
            text.transform.position = new Vector3(1, 2, 3);
            var distance = new ReadingDistance();

            distance.Face(text, new Vector3(1, 1.5f, 1));

            Assert.That(text.transform.lossyScale.x * 6.4f, Is.EqualTo(LetterSize.At(distance.Metres)).Within(1e-5));
            Assert.That(text.transform.forward.z, Is.EqualTo(1).Within(1e-5), "texts are read along their z axis");
            Assert.That(text.transform.up.y, Is.EqualTo(1).Within(1e-5), "the text is upright although the viewer looks up");
        }

        [Test]
        public void Facing_ViewerDirectlyBelow_StaysUpright()
        {
            Assert.That(Viewer.Facing(new Vector3(0, 2, 0), Vector3.zero), Is.EqualTo(Quaternion.identity));
        }
    }
}
