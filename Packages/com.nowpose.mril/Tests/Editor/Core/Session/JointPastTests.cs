using System;
using Nowpose.Frames;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Checks the positions of joints at times before the samples of their predictors, from which grips are decided.</summary>
    public class JointPastTests
    {
        static readonly int Shoulder = TestRobot.Model.IndexOfMovingJoint("shoulder");

        // The elbow is a continuous joint: its angles wrap from π to −π. The predictor keeps only the newest samples.
        [TestCase("linear", 0.01)]
        [TestCase("hold", 0.05)]
        [TestCase("adaptive", 0.004)]
        public void At_TimeBeforeTheSamplesOfThePredictor_IsMeasuredForMoreThanASecond(string predictor, double interval)
        {
            var tracks = new JointTracks(TestRobot.Model, new PredictionSettings(predictor));
            var joints = new[] { Shoulder, TestRobot.Model.IndexOfMovingJoint("elbow") };
            double Elbow(double t) => Math.IEEERemainder(3 * t, 2 * Math.PI);
            void Add(double t) => tracks.Add(
                new JointStateMessage(ControlTime.FromSeconds(100 + t), new[] { "shoulder", "elbow" }, new[] { Math.Sin(t), Elbow(t) }), joints);
            for (var k = 0; k * interval < 3; k++) Add(k * interval);
            var positions = new double[TestRobot.Model.MovingJoints.Count];

            for (var t = 1.8; t < 2.9; t += 0.013)
            {
                Assert.That(tracks.At(ControlTime.FromSeconds(100 + t), joints, positions), Is.EqualTo(PoseOrigin.Measured), $"{t} s");
                Assert.That(positions[joints[0]], Is.EqualTo(Math.Sin(t)).Within(1e-3));
                Assert.That(Math.IEEERemainder(positions[joints[1]] - Elbow(t), 2 * Math.PI), Is.Zero.Within(1e-9));
            }
            Assert.That(tracks.At(ControlTime.FromSeconds(99), joints, positions), Is.EqualTo(PoseOrigin.None));

            for (var k = 0; k < 5; k++) Add(-10 + k * interval);
            Assert.That(tracks.At(ControlTime.FromSeconds(102.5), joints, positions), Is.EqualTo(PoseOrigin.None), "the clock went back");
        }

        // The sample with the wrong stamp must not hide those that follow, from the past and from the truth of the errors.
        [TestCase(0.09)]
        [TestCase(0.3)]
        [TestCase(0.9)]
        public void Add_OneStampInTheFuture_ThePastIsThatOfTheOtherSamples(double future)
        {
            var (tracks, restarts) = (new JointTracks(TestRobot.Model, PredictionSettings.Default), 0);
            tracks.Restarted += _ => restarts++;
            var joints = new[] { Shoulder };
            for (var k = 0; k < 60; k++)
                tracks.Add(new JointStateMessage(
                    ControlTime.FromSeconds(100 + 0.05 * k + (k == 40 ? future : 0)), new[] { "shoulder" }, new[] { Math.Sin(0.15 * k) }), joints);
            var positions = new double[TestRobot.Model.MovingJoints.Count];

            for (var t = 2.15; t < 2.9; t += 0.013)
            {
                Assert.That(tracks.At(ControlTime.FromSeconds(100 + t), joints, positions), Is.EqualTo(PoseOrigin.Measured), $"{t} s");
                Assert.That(positions[Shoulder], Is.EqualTo(Math.Sin(3 * t)).Within(3e-3), $"{t} s");
            }
            Assert.That(restarts, Is.EqualTo(1));
        }
    }
}
